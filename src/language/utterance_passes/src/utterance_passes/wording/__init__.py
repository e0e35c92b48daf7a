"""How is the text spelled, and where does a command begin in it?"""
