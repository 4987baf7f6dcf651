"""Tests of samplers: laws, second implementations (twins) to compare with, and planted defects that test the laws."""
