"""What is a parsed sentence, and how is one made of another?"""
