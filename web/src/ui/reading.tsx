import { words } from '../words';

/** A page of which nothing is known yet, and why. */
export function Reading() {
  const said = words.value.reading;
  return (
    <div class="page">
      <section>
        <h1>{said.title}</h1>
        <p class="hint">{said.lost}</p>
      </section>
    </div>
  );
}
