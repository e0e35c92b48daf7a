"""What is a sentence, a reading, a plan of clauses, an outcome?"""
