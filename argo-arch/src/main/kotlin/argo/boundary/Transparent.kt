package argo.boundary

/**
 * An architecture that passes every input of its agent on unchanged. Agents that have only such architectures besides `argo.Arch` can be
 * recorded.
 */
interface Transparent
