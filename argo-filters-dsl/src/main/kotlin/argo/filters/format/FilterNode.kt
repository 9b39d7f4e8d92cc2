package argo.filters.format

/** A value in a filter's document, with its position and its text for messages. A document in XML gets the shape of one in JSON. */
internal sealed class FilterNode(val position: Position, val words: String) {
    class Object(position: Position, val members: List<Member>) : FilterNode(position, "an object")

    class Array(position: Position, val items: List<FilterNode>) : FilterNode(position, "an array")

    /**
     * @property isText whether a text may be written so: in JSON only in quotes, in XML always
     * @property isBare whether a number or truth value may be written so: in JSON only without quotes, in XML always
     */
    class Scalar(position: Position, val content: String, val isText: Boolean, val isBare: Boolean) :
        FilterNode(position, if (isText) "'$content'" else content)

    /** A value that is missing or wrong, which needs no further report. */
    class Refused(position: Position) : FilterNode(position, "")

    /** @property words the member with its value, for messages */
    class Member(val name: String, val position: Position, val value: FilterNode, val words: String = "\"$name\" is ${value.words}")
}
