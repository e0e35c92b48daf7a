"""What is nearest to what was said, and what persons taught by their answers."""
