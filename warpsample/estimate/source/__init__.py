"""The user's functions and data as Python and Warp hold them: what they stand for now, and what tells two apart."""
