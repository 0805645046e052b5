def main():
    print('I drive my_robot.')


if __name__ == '__main__':
    main()
