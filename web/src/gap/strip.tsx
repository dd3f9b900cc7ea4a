interface Props {
  title: string;
  cells: { name: string; value: string; tint: number }[];
}

/** A row of numbers, the larger the stronger their tint. */
export function Strip({ title, cells }: Props) {
  return (
    <figure class="strip">
      <figcaption>{title}</figcaption>
      <ol>
        {cells.map(({ name, value, tint }, k) => (
          <li key={k} class={`tint tint-${tint}`}>
            {name && <small>{name}</small>} <b>{value}</b>
          </li>
        ))}
      </ol>
    </figure>
  );
}
