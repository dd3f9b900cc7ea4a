"""What whoever looks after the service needs: versions, disk space, and the bundle that an engineer can send."""
