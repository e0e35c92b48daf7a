"""What does a question ask, and of which frame?"""
