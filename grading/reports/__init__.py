"""Reports for a school's systems, its teachers and its students, made from RESULTS/results.json.

`python -m reports RESULTS` writes everything. Each format has a module. Only visibility.py decides
what a student may see, and all text from a submission passes through text.py.
"""
