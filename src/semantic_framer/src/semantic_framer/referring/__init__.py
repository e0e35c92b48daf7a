"""Which thing, person or place is meant?"""
