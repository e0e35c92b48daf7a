"""How do conditions, times and lists join the deeds of a sentence?"""
