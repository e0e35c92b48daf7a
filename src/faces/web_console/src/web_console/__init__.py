"""A page in the browser: what the robot hears, understands, plans and does."""
