"""The sun: from where it stands, which points see it."""
