interface Props {
  /** The sentence in the chosen language, where its catalogue has it. */
  said: string | undefined;
  /** As the engine says it. */
  english: string;
}

/** A sentence that the engine says, in the chosen language as far as that knows it. */
export function EngineSentence({ said, english }: Props) {
  return <span lang={said === undefined ? 'en' : undefined}>{said ?? english}</span>;
}
