"""Which words fill which element of a frame?"""
