"""Light that faces send back, once or many times: diffuse reflections between the faces of a mesh."""
