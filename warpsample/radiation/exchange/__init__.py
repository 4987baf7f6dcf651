"""Light that faces exchange: view factors and radiosity."""
