"""What does a fragment change in the last command?"""
