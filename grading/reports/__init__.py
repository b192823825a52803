"""What a school's systems, its teachers and its students read, made from RESULTS/results.json.

`python -m reports RESULTS` writes everything. Each format has a module; what a student may see is
decided in visibility.py alone, and text that came from a submission passes through text.py alone.
"""
