request-unfit = { $more ->
    [0] { $flaw }
   *[other] { $flaw }; and { $more } more, see `flaws`
}
request-no-json = { $flaw }
request-address-unknown = { $method } { $path }: there is nothing at this address; GET /openapi.json lists what there is
request-method-not-allowed = { $method } { $path }: this address does not know the method; see `allowed`
request-body-too-large = { $method } { $path }: the body is larger than { $limit_bytes } bytes; send a smaller one
request-refused = { $method } { $path }: { $reason }
request-unforeseen = an error that was not foreseen; the service's log has it under request_id
request-key-busy = Idempotency-Key "{ $key }": the first request is still under way; ask again
request-key-reused = Idempotency-Key "{ $key }": was used for another body already; take a new key for a new request
request-cell-unknown = cell: there is none called "{ $cell }". List what there is and ask again.
request-problem-unknown = problem: there is none called "{ $problem }". GET /openapi.json lists what there is.
request-console-file-unknown = file of the console: there is none called "{ $path }". Load the page again.
