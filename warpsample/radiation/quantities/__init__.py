"""Quantities of sun, sky and reflected light as the command line and stores compute them, one file each."""
