"""Which deed do several words mean together?"""
