import type { ProblemDetails, paths, SessionPublic } from '../api';
import { csrfToken, session } from '../session/session';
import { heard, unheard } from './connection';
import { Refusal } from './refusal';

type Method = 'get' | 'post' | 'put' | 'patch' | 'delete';
type Path = keyof paths & string;

/** How long an answer may take. A line that swallows everything ends no request, and the screen would go on saying that all is well. */
const PATIENCE_MS = { get: 5_000, others: 30_000 };

/** Every endpoint by the name that the service's table of authority gives it: "GET /api/runs/{run}". */
export type Endpoint = {
  [P in Path]: {
    [M in Method]: paths[P][M] extends { responses: unknown } ? `${Uppercase<M>} ${P}` : never;
  }[Method];
}[Path];

type Operation<E> = E extends `${infer M} ${infer P}`
  ? P extends Path
    ? Lowercase<M> extends keyof paths[P]
      ? paths[P][Lowercase<M>]
      : never
    : never
  : never;
type Parameters<O, K extends string> = O extends { parameters: { [key in K]?: infer T } } ? T : never;
type Body<O> = O extends { requestBody?: infer R }
  ? [R] extends [{ content: { 'application/json': infer T } } | undefined]
    ? T
    : never
  : never;
type Json<R> = R extends { content: { 'application/json': infer T } } ? T : never;
type Good<O> = O extends { responses: infer R }
  ? { [S in keyof R]: S extends 200 | 201 | 202 ? Json<R[S]> : never }[keyof R]
  : never;

export interface Asked<O> {
  path?: Parameters<O, 'path'>;
  query?: Parameters<O, 'query'>;
  header?: Parameters<O, 'header'>;
  body?: Body<O>;
  /** A zip in place of a body, or another file, whose type says so. */
  zip?: Blob;
  /** How long the answer may take, where that is not as long as for others. */
  patience_ms?: number;
}

/**
 * Asks the service.
 *
 * @throws Refusal: it says no; TypeError: it cannot be reached; TimeoutError: it is not heard of. A zip takes as long as it takes.
 */
export async function ask<E extends Endpoint>(
  endpoint: E,
  asked: Asked<Operation<E>> = {},
): Promise<Good<Operation<E>>> {
  const [method = 'GET', template = ''] = endpoint.split(' ');
  const headers = new Headers(entries(asked.header));
  if (method !== 'GET') headers.set('X-CSRF-Token', csrfToken.value ?? '');
  const body = asked.zip ?? (asked.body === undefined ? null : JSON.stringify(asked.body));
  if (body !== null) headers.set('Content-Type', contentType(asked.zip));
  const patience_ms = asked.patience_ms ?? (method === 'GET' ? PATIENCE_MS.get : PATIENCE_MS.others);
  const signal = asked.zip ? null : AbortSignal.timeout(patience_ms);
  const response = await reached(addressOf(template, asked.path, asked.query), {
    method,
    headers,
    body,
    signal,
  });
  return (response.status === 204 ? undefined : await response.json()) as Good<Operation<E>>;
}

/** Of a file that is no zip, as the service wants it. */
export const PLAIN_FILE = 'application/octet-stream';

function contentType(file: Blob | undefined): string {
  if (file === undefined) return 'application/json';
  return file.type === PLAIN_FILE ? PLAIN_FILE : 'application/zip';
}

/** An address of the service, its braces filled in. */
export function addressOf(template: string, path?: object, query?: object): string {
  const filled = entries(path).reduce(
    (text, [name, value]) => text.replace(`{${name}}`, encodeURIComponent(value)),
    template,
  );
  const search = new URLSearchParams(entries(query)).toString();
  return search ? `${filled}?${search}` : filled;
}

/** The address of a websocket of the service. */
export function socketAddress(path: string): string {
  return `${location.origin.replace(/^http/, 'ws')}${path}`;
}

/** Whatever is not there does not go out. */
function entries(of: object = {}): [string, string][] {
  return Object.entries(of).flatMap(([name, value]) =>
    [value].flat().flatMap((each): [string, string][] => (each == null ? [] : [[name, String(each)]])),
  );
}

/**
 * Sends a file in place of a body, and tells what share of it is on its way; takes as long as it takes.
 *
 * @throws Refusal: the service says no; TypeError: it cannot be reached.
 */
export async function send<E extends Endpoint>(
  endpoint: E,
  { path }: Pick<Asked<Operation<E>>, 'path'>,
  file: Blob,
  tell: (share: number) => void,
): Promise<Good<Operation<E>>> {
  const [method = 'PUT', template = ''] = endpoint.split(' ');
  const response = await new Promise<Response>((resolve, reject) => {
    const request = new XMLHttpRequest(); // fetch does not tell how much has gone
    request.open(method, addressOf(template, path));
    request.setRequestHeader('X-CSRF-Token', csrfToken.value ?? '');
    request.setRequestHeader('Content-Type', PLAIN_FILE);
    request.upload.onprogress = ({ loaded, total }) => tell(total > 0 ? loaded / total : 0);
    request.onload = () => resolve(answerOf(request));
    request.onerror = () => {
      unheard();
      reject(new TypeError('the service cannot be reached'));
    };
    request.send(file);
  });
  return (await judged(response)).json() as Promise<Good<Operation<E>>>;
}

function answerOf(request: XMLHttpRequest): Response {
  const headers = new Headers();
  for (const name of ['Content-Type', 'Date', 'X-Request-Id'])
    headers.set(name, request.getResponseHeader(name) ?? '');
  const { status, statusText } = request;
  return new Response(request.responseText, { status, statusText, headers });
}

async function reached(address: string, request: RequestInit): Promise<Response> {
  const response = await fetch(address, request).catch((error) => {
    if (error instanceof TypeError) unheard();
    throw error;
  });
  return judged(response);
}

/** An answer that is none is thrown. */
async function judged(response: Response): Promise<Response> {
  heard(response);
  if (response.ok) return response;
  if (response.status === 401) session.value = null;
  if (response.status === 403) await renewSession();
  throw new Refusal(await problemOf(response));
}

/** Somebody may have signed out and in again in another tab: then the token of this one is no longer good, and the next try has the new. */
async function renewSession(): Promise<void> {
  const response = await fetch('/api/session');
  if (response.ok) session.value = (await response.json()) as SessionPublic;
}

async function problemOf(response: Response): Promise<ProblemDetails> {
  const said: unknown = await response.json().catch(() => null);
  if (isProblem(said)) return said;
  const title = `${response.status} ${response.statusText}`;
  const request_id = response.headers.get('X-Request-Id') ?? '';
  return { type: 'about:blank', title, status: response.status, detail: title, kind: '', request_id };
}

function isProblem(said: unknown): said is ProblemDetails {
  return typeof said === 'object' && said !== null && 'detail' in said && 'title' in said;
}
