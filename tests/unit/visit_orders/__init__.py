"""Orders of visits in LTL, and a simulated robot that makes them: shares nothing with what understands sentences."""
