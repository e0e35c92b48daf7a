"""Several robots with one language service: who is addressed, who is there, and what a robot does on its own."""
