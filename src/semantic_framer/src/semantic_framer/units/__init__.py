"""Which frames and lexical units does the robot know, and what do they ask for?"""
