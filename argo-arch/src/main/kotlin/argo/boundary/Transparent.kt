package argo.boundary

/** An architecture that hands every input of its agent on unchanged. An agent that has it besides `argo.Arch` can be recorded. */
interface Transparent
