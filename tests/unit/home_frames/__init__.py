"""Which frames of the domains are grounded in the home, and which sentences of tests carry each of them out."""
