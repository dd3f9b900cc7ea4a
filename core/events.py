"""What happens during a run, one frozen model per event. The command line prints them, the server will store and broadcast them."""
