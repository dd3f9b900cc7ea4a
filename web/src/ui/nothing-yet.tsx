import type { ComponentChildren } from 'preact';

interface Props {
  children: ComponentChildren;
  /** Where to go for that to change, and what that is called. */
  href?: string;
  act?: string;
}

/** In the place of a list that has nothing in it: why, and what to do. */
export function NothingYet({ children, href, act }: Props) {
  return (
    <div class="empty" role="status">
      <p>{children}</p>
      {href && (
        <a class="download" href={href}>
          {act}
        </a>
      )}
    </div>
  );
}
