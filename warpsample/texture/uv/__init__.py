"""Texture coordinates: detection of charts in existing coordinates, and new coordinates by xatlas."""
