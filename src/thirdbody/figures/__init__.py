"""The figures of the paper: each function takes data and returns a matplotlib figure."""
