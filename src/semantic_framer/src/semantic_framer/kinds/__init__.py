"""Is a clause a command, a question, a report, a wish or talk?"""
