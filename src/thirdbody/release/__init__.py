"""What goes to an archive: the products with their descriptions, sums and the means to check them."""
