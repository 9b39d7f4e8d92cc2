package argo.boundary

/** An architecture that hands on all that enters its agent as it is. An agent that has it besides `argo.Arch` can be recorded. */
interface Transparent
