package argo.boundary

/** An architecture that hands on every input of its agent unchanged. An agent with it besides `argo.Arch` can be recorded. */
interface Transparent
