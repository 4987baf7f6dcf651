"""Radiation exchanged between faces: view factors, radiosity and net thermal radiation."""
