"""Looking at traffic, live or captured: messages one by one, rates, and who talks to whom."""
