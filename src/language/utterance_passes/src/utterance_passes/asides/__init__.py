"""Which words say why or how politely, and not what to do?"""
