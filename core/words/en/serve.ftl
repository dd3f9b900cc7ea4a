serve-data-in-use =
    .found = a service that runs on it already
    .expected = a folder of its own (--data DIR)
serve-no-store =
    .found = no { $file }
    .expected = the data folder of a service (--data DIR)

# What whoever starts the service reads.
serve-started = Heft { $version }, data in { $folder }
serve-first-account = First account: { $account }, password { $password }
serve-open-once = Open this address once; there you choose your own password:
