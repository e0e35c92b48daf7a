"""The command line ``rfn``."""
