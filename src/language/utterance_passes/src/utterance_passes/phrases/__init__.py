"""Which clauses, amounts and times are in a sentence?"""
