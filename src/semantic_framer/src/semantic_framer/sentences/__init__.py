"""What does a whole sentence mean?"""
