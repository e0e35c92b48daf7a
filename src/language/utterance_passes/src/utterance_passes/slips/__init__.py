"""What did the speaker take back, or say twice?"""
