package argo.filters.format

/** A value in a filter's document, with its position and its text for messages. An XML document takes the same form as a JSON document. */
internal sealed class FilterNode(val position: Position, val words: String) {
    class Object(position: Position, val members: List<Member>) : FilterNode(position, "an object")

    class Array(position: Position, val items: List<FilterNode>) : FilterNode(position, "an array")

    /**
     * @property isText whether the scalar can be a text: in JSON if it is in quotes, in XML always
     * @property isBare whether the scalar can be a number or truth value: in JSON if it has no quotes, in XML always
     */
    class Scalar(position: Position, val content: String, val isText: Boolean, val isBare: Boolean) :
        FilterNode(position, if (isText) "'$content'" else content)

    /** Replaces a missing or wrong value that has already been reported. */
    class Refused(position: Position) : FilterNode(position, "")

    class Member(val name: String, val position: Position, val value: FilterNode, val words: String = "\"$name\" is ${value.words}")
}
