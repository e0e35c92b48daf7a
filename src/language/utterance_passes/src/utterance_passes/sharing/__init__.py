"""Which verb, object or list do phrases share?"""
