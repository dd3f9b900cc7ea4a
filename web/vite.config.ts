import { defineConfig, loadEnv } from 'vite';

/** What pages that come later share with those that come at first, in one file: many small ones are larger, and slower to ask for. */
const SHARED = { name: 'shared', test: /src\/(cells|run|session|ui)\//, minShareCount: 2 };

/** `npx vite` serves the sources beside a running service: HEFT_HOST and HEFT_PORT say where that is. */
export default defineConfig(({ mode }) => {
  const { HEFT_HOST = '127.0.0.1', HEFT_PORT = '8000' } = loadEnv(mode, '.', 'HEFT_');
  const proxied = { target: `http://${HEFT_HOST}:${HEFT_PORT}`, ws: true };
  return {
    build: {
      target: ['chrome123', 'firefox128', 'safari17.5'],
      rolldownOptions: { output: { codeSplitting: { groups: [SHARED] } } },
    },
    worker: { format: 'es' },
    // The words of messages stand beside the engine, the manual beside all.
    server: {
      proxy: { '/api': proxied, '/viewer': proxied },
      fs: { allow: ['.', '../core/words', '../docs'] },
    },
  };
});
