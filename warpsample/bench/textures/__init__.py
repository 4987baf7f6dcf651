"""`bench textures`: time and error of ambient occlusion in a texture, for each tool."""

from warpsample.bench.textures.baking import RECORD as RECORD
