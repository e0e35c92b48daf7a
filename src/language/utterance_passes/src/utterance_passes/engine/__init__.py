"""What is a pass, and how do passes run?"""
