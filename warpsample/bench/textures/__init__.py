"""`bench textures`: ambient occlusion in a texture by each tool."""

from warpsample.bench.textures.baking import RECORD as RECORD
