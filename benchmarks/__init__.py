"""What an ``rtol`` costs and what it buys: errors against multiple precision, times, baselines."""
