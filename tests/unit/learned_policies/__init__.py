"""Policies compared on simulated servers: 20 servers for 6 frames, with contexts and drift."""
