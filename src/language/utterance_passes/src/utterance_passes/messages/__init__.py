"""Which words are to be said, or are spoken about?"""
