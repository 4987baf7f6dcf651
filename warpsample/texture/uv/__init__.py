"""Texture coordinates: charts of given ones, and new ones by xatlas."""
