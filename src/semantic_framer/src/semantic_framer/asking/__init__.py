"""What is still open, and what does an answer settle?"""
