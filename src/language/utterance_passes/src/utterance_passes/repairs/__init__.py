"""Where does the parser attach words wrongly?"""
