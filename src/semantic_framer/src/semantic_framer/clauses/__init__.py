"""What does one clause mean?"""
