"""Accepts commands as text or by action; exactly one reply to each."""
