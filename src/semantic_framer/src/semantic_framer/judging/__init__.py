"""Which readings are refused or dropped, and why?"""
