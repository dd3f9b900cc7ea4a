"""HTTP for all nouns: schemas, problems (RFC 9457), middleware, the OpenAPI description, downloads and uploads, the console's files."""
